// SPDX-License-Identifier: GPL-3.0-or-later
// Shows what /events sends (boardState in ui/scoreboard/internal/board_page.h). Names are text, never markup.
'use strict';

const byId = (id) => document.getElementById(id);
const columns = ['rank', 'team', 'value', 'behind', 'best', 'last', 'runs'];
let known = new Map(); // what was shown of each team
let shownMap = 0;
let clock = 0; // the timer of the run that is going on

function element(name, className, text) {
  const made = document.createElement(name);
  made.className = className;
  made.textContent = text;
  return made;
}

function cellOf(column, team) {
  const cell = element(column === 'team' ? 'th' : 'td', column, column === 'team' ? '' : team[column] || '');
  if (column === 'team') {
    cell.scope = 'row';
    cell.append(element('span', 'name', team.team));
    if (team.of) cell.append(element('small', 'of', team.of));
  }
  if (column === 'value' && team.sigma) cell.append(element('small', 'sigma', ' ±' + team.sigma));
  if (column === 'behind' && team.isNear) cell.prepend(element('span', 'near', '≈ '));
  cell.dataset.head = document.querySelector('thead .' + column).firstChild.textContent;
  return cell;
}

/** Names that do not fit on their line get two smaller ones. */
function fitNames() {
  const names = [...document.querySelectorAll('.name')];
  names.forEach((name) => name.classList.remove('long'));
  const long = names.filter((name) => name.scrollWidth > name.clientWidth);
  long.forEach((name) => name.classList.add('long'));
}

function showTeams(teams) {
  const rows = [];
  const now = new Map();
  let before = null;
  for (const team of teams) {
    const key = team.team + '\n' + (team.of || '');
    const state = JSON.stringify([team.value, team.best, team.last, team.runs]);
    const row = element('tr', '', '');
    row.append(...columns.map((column) => cellOf(column, team)));
    row.classList.toggle('first', team.rank !== '' && team.rank === teams[0].rank);
    row.classList.toggle('tied', team.rank !== '' && before === team.rank);
    row.classList.toggle('changed', known.size > 0 && known.get(key) !== state);
    before = team.rank;
    now.set(key, state);
    rows.push(row);
  }
  known = now;
  byId('teams').replaceChildren(...rows);
  document.documentElement.style.setProperty('--rows', String(Math.max(6, teams.length)));
}

function showRunning(running) {
  clearInterval(clock);
  byId('running').hidden = !running;
  if (!running) return;
  const began = performance.now() - 1000 * running.seconds;
  const tick = () => {
    const seconds = Math.max(0, Math.floor((performance.now() - began) / 1000));
    byId('clock').textContent = Math.floor(seconds / 60) + ':' + String(seconds % 60).padStart(2, '0');
  };
  byId('runningWords').textContent = running.words;
  byId('runningTeam').textContent = running.team;
  tick();
  clock = setInterval(tick, 250);
}

async function showMap(version, words) {
  byId('bestRun').hidden = !version;
  byId('mapWords').textContent = words || '';
  if (!version || version === shownMap) return;
  shownMap = version;
  try {
    const answer = await fetch('/map?' + version);
    const drawn = new DOMParser().parseFromString(await answer.text(), 'text/html').querySelector('svg');
    if (drawn && version === shownMap) byId('map').replaceChildren(document.adoptNode(drawn));
  } catch (error) {
    shownMap = 0; // with the next message
  }
}

function show(state) {
  const title = state.task || byId('task').dataset.title;
  byId('task').textContent = title;
  document.title = title;
  byId('facts').textContent = state.facts.join(' · ');
  byId('unit').textContent = state.unit ? ' (' + state.unit + ')' : '';
  byId('standings').hidden = state.teams.length === 0;
  byId('rule').hidden = !state.teams.some((team) => team.rank);
  byId('empty').hidden = !state.empty;
  byId('empty').textContent = state.empty || '';
  byId('notes').replaceChildren(...state.notes.map((note) => element('li', '', note)));
  showTeams(state.teams);
  showRunning(state.running);
  showMap(state.map, state.mapWords);
  fitNames();
}

/** Where nobody scrolls, as on a projector, the page turns by itself if not all teams fit. */
function turnPages() {
  const secondsPerPage = 10, secondsAfterTouch = 60;
  let waiting = 0;
  for (const touch of ['wheel', 'keydown', 'pointerdown'])
    addEventListener(touch, () => { waiting = secondsAfterTouch / secondsPerPage; }, { passive: true });
  setInterval(() => {
    if (!matchMedia('(min-width:64rem)').matches || waiting-- > 0) return;
    waiting = 0;
    const isAtEnd = scrollY + innerHeight >= document.documentElement.scrollHeight - 2;
    scrollTo({ top: isAtEnd ? 0 : scrollY + 0.8 * innerHeight, behavior: 'smooth' });
  }, 1000 * secondsPerPage);
}

function follow() {
  const source = new EventSource('/events');
  source.onmessage = (event) => {
    byId('link').hidden = true;
    show(JSON.parse(event.data));
  };
  source.onerror = () => {
    byId('link').textContent = byId('link').dataset.lost;
    byId('link').hidden = false;
    shownMap = 0; // another server may count its maps anew
    if (source.readyState !== EventSource.CLOSED) return; // it tries again by itself
    source.close();
    setTimeout(follow, 2000);
  };
}

addEventListener('resize', fitNames);
turnPages();
follow();
