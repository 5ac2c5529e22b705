// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/hub_argument.h"

namespace odo {

Result<HubAddress> hubAddressAt(const CommandCall &call, int index)
{
    auto address = HubAddress::parse(call.text(index));
    if (!address)
        return fail(ErrorCode::WrongCall, address.error().what, address.error().why, address.error().advice);
    return address;
}

} // namespace odo
