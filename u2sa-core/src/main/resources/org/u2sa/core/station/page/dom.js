// Elements of the page. Whatever comes from a vehicle is set as text, never as markup.

export const byId = id => document.getElementById(id);

export function element(name, text = '', properties = {}) {
  return Object.assign(document.createElement(name), {textContent: text}, properties);
}

/** Sets a text only if it changes, so that screen readers repeat nothing. */
export function setText(target, text) {
  if (target.textContent !== text) target.textContent = text;
}

/** Replaces the children if they differ; otherwise the focus would be lost. */
export function fill(parent, values, make) {
  const children = values.map(make);
  const isSame = children.length === parent.children.length && children.every((child, i) => child.outerHTML === parent.children[i].outerHTML);
  if (!isSame) parent.replaceChildren(...children);
}

export function row({cells, state}) {
  const line = element('tr');
  line.className = state;
  line.append(...cells.map(text => element('td', text)));
  return line;
}

/** A button in the first cell of a row. */
export function buttonRow({cells: [name, ...cells], state}, isPressed, action) {
  const line = row({cells: ['', ...cells], state});
  const button = element('button', '', {type: 'button', onclick: action});
  button.append(...name.split(/(?<=[a-z])(?=[A-Z])/).flatMap((word, i) => i === 0 ? [word] : [element('wbr'), word])); // long names break between words
  button.setAttribute('aria-pressed', isPressed);
  line.firstChild.append(button);
  return line;
}

export function age(at) {
  const seconds = (performance.now() - at) / 1000;
  return seconds < 10 ? seconds.toFixed(1) + ' s' : seconds < 1e6 ? Math.round(seconds) + ' s' : 'ever';
}
