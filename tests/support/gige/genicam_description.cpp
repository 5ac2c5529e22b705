// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/gige/genicam_description.h"

#include "tests/support/gige/gige_registers.h"

#include <sstream>
#include <vector>

namespace odo::test {

namespace {

/// Collects nodes, and names those that belong to the root category.
class Description
{
public:
    void integer(const std::string &name, std::uint32_t address, const std::string &limits,
                 const char *access = "RW", int length = 4)
    {
        m_features.push_back(name);
        m_nodes << "<Integer Name=\"" << name << "\"><pValue>" << name << "Reg</pValue>" << limits
                << "</Integer>\n";
        intRegister(name, address, access, length);
    }
    void real(const std::string &name, std::uint32_t address, const char *unit, const std::string &limits,
              const std::string &lock = {})
    {
        m_features.push_back(name);
        m_nodes << "<Float Name=\"" << name << "\">"
                << (lock.empty() ? "" : "<pIsLocked>" + lock + "Reg</pIsLocked>") << "<pValue>" << name
                << "Reg</pValue>" << limits << "<Unit>" << unit << "</Unit></Float>\n<FloatReg Name=\""
                << name << "Reg\">" << place(address, "RW", 4)
                << "<Endianess>BigEndian</Endianess></FloatReg>\n";
    }
    void choice(const std::string &name, std::uint32_t address,
                const std::vector<std::pair<const char *, std::uint32_t>> &entries)
    {
        m_features.push_back(name);
        m_nodes << "<Enumeration Name=\"" << name << "\">";
        for (const auto &[entry, value] : entries)
            m_nodes << "<EnumEntry Name=\"" << entry << "\"><Value>" << value << "</Value></EnumEntry>";
        m_nodes << "<pValue>" << name << "Reg</pValue></Enumeration>\n";
        intRegister(name, address, "RW", 4);
    }
    void command(const std::string &name, std::uint32_t address, std::uint32_t value)
    {
        m_features.push_back(name);
        m_nodes << "<Command Name=\"" << name << "\"><pValue>" << name << "Reg</pValue><CommandValue>"
                << value << "</CommandValue></Command>\n";
        intRegister(name, address, "RW", 4);
    }
    void text(const std::string &name, std::uint32_t address, int length)
    {
        m_features.push_back(name);
        m_nodes << "<StringReg Name=\"" << name << "\">" << place(address, "RO", length) << "</StringReg>\n";
    }
    std::string finish() const
    {
        std::ostringstream whole;
        whole << R"(<?xml version="1.0" encoding="utf-8"?>
<RegisterDescription ModelName="Simulated" VendorName="Odograph" ToolTip="" StandardNameSpace="GEV" SchemaMajorVersion="1"
 SchemaMinorVersion="1" SchemaSubMinorVersion="0" MajorVersion="1" MinorVersion="0" SubMinorVersion="0"
 ProductGuid="5b3b0a0e-6f0e-4f39-9d3c-0d6f4ba4c001" VersionGuid="5b3b0a0e-6f0e-4f39-9d3c-0d6f4ba4c002"
 xmlns="http://www.genicam.org/GenApi/Version_1_1">
<Category Name="Root" NameSpace="Standard">)";
        for (const std::string &feature : m_features)
            whole << "<pFeature>" << feature << "</pFeature>";
        whole << "</Category>\n"
              << m_nodes.str()
              << "<Port Name=\"Device\" NameSpace=\"Standard\"></Port>\n</RegisterDescription>\n";
        return whole.str();
    }

private:
    static std::string place(std::uint32_t address, const char *access, int length)
    {
        std::ostringstream words;
        words << "<Address>" << address << "</Address><Length>" << length << "</Length><AccessMode>" << access
              << "</AccessMode><pPort>Device</pPort><Cachable>NoCache</Cachable>";
        return words.str();
    }
    void intRegister(const std::string &name, std::uint32_t address, const char *access, int length)
    {
        m_nodes << "<IntReg Name=\"" << name << "Reg\">" << place(address, access, length)
                << "<Sign>Unsigned</Sign><Endianess>BigEndian</Endianess></IntReg>\n";
    }

    std::vector<std::string> m_features;
    std::ostringstream m_nodes;
};

std::string limits(double least, double most, int step = 0)
{
    std::ostringstream words;
    words.precision(12); // no exponents
    words << "<Min>" << least << "</Min><Max>" << most << "</Max>";
    if (step > 0)
        words << "<Inc>" << step << "</Inc>";
    return words.str();
}

void describeFrame(Description &description)
{
    description.integer("WidthMax", reg::SensorWidth, {}, "RO");
    description.integer("HeightMax", reg::SensorHeight, {}, "RO");
    description.integer("Width", reg::Width, "<Min>16</Min><pMax>WidthMax</pMax><Inc>2</Inc>");
    description.integer("Height", reg::Height, "<Min>16</Min><pMax>HeightMax</pMax><Inc>2</Inc>");
    description.integer("OffsetX", reg::OffsetX, limits(0, 4096, 2));
    description.integer("OffsetY", reg::OffsetY, limits(0, 4096, 2));
    description.choice("PixelFormat", reg::PixelFormat,
                       {{"Mono8", 0x01080001},
                        {"BayerGR8", 0x01080008},
                        {"BayerRG8", 0x01080009},
                        {"BayerGB8", 0x0108000a},
                        {"BayerBG8", 0x0108000b},
                        {"RGB8", 0x02180014},
                        {"BGR8", 0x02180015}});
    description.integer("PayloadSize", reg::Payload, {}, "RO");
}

void describeAcquisition(Description &description, bool automatics)
{
    description.choice("AcquisitionMode", reg::AcquisitionMode, {{"Continuous", 0}, {"SingleFrame", 1}});
    description.command("AcquisitionStart", reg::Acquisition, 1);
    description.command("AcquisitionStop", reg::Acquisition, 0);
    description.real("AcquisitionFrameRate", reg::FrameRate, "Hz", limits(0.1, 1000));
    description.real("ExposureTime", reg::ExposureTime, "us", limits(10, 1e6),
                     automatics ? "ExposureAuto" : "");
    description.real("Gain", reg::Gain, "dB", limits(0, 24), automatics ? "GainAuto" : "");
    if (automatics) {
        for (const auto &[name, address] :
             {std::pair{"ExposureAuto", reg::ExposureAuto}, std::pair{"GainAuto", reg::GainAuto}})
            description.choice(name, address, {{"Off", 0}, {"Once", 1}, {"Continuous", 2}});
    }
    description.choice("TriggerSelector", reg::TriggerSelector, {{"FrameStart", 0}});
    description.choice("TriggerMode", reg::TriggerMode, {{"Off", 0}, {"On", 1}});
    description.choice("TriggerSource", reg::TriggerSource, {{"Software", 0}, {"Line1", 1}});
    description.choice("TriggerActivation", reg::TriggerActivation, {{"RisingEdge", 0}});
    description.command("TriggerSoftware", reg::TriggerSoftware, 1);
}

void describeTransport(Description &description, bool timestampLatch)
{
    description.text("DeviceVendorName", reg::Vendor, 32);
    description.text("DeviceModelName", reg::Model, 32);
    description.text("DeviceSerialNumber", reg::Serial, 16);
    description.integer("GevSCPSPacketSize", reg::PacketSize, limits(100, 16400, 4));
    description.command("GevSCPSFireTestPacket", reg::PacketSize, 0x80000000u);
    description.integer("GevSCPD", reg::PacketDelay, limits(0, 1e9));
    description.integer("GevTimestampTickFrequency", reg::TickFrequencyHigh, {}, "RO", 8);
    if (timestampLatch) {
        description.command("GevTimestampControlLatch", reg::TimestampControl, 2);
        description.command("GevTimestampControlReset", reg::TimestampControl, 1);
        description.integer("GevTimestampValue", reg::TimestampHigh, {}, "RO", 8);
    }
}

} // namespace

std::string genicamDescription(const GenicamAbilities &abilities)
{
    Description description;
    describeFrame(description);
    describeAcquisition(description, abilities.automatics);
    describeTransport(description, abilities.timestampLatch);
    return description.finish();
}

} // namespace odo::test
