// A small XML reader with line numbers, as mission files need it: no DTD, no namespaces, nothing executed.

const MAX_DEPTH = 16;
const ENTITIES = {amp: '&', lt: '<', gt: '>', quot: '"', apos: "'"};
const NAME = /[A-Za-z_][\w.-]*/y;

export class XmlError extends Error {
  constructor(line, what) {
    super(what);
    this.line = line;
  }
}

/** The root element: {name, attributes, children, text, line, source}. Throws {@link XmlError}. */
export function readXml(text) {
  const reader = new XmlReader(text);
  reader.misc();
  const root = reader.element(0);
  reader.misc();
  if (reader.at < text.length) throw reader.error('text after the last element');
  return root;
}

class XmlReader {
  constructor(text) {
    this.text = text;
    this.at = 0;
    this.lines = 1;
    this.countedTo = 0;
  }

  error(what) {
    return new XmlError(this.line(this.at), what);
  }

  /** Number of the line of a place; counted on from the last one. */
  line(at) {
    for (; this.countedTo < at; this.countedTo++) if (this.text.charCodeAt(this.countedTo) === 10) this.lines++;
    return this.lines;
  }

  has(part) {
    return this.text.startsWith(part, this.at);
  }

  /** Passes to behind a text that must come. */
  past(part, what) {
    const end = this.text.indexOf(part, this.at);
    if (end < 0) throw this.error(`${what} without its end "${part}"`);
    const inside = this.text.slice(this.at, end);
    this.at = end + part.length;
    return inside;
  }

  blanks() {
    while (/\s/.test(this.text.charAt(this.at))) this.at++;
  }

  name() {
    NAME.lastIndex = this.at;
    const found = NAME.exec(this.text);
    if (!found) throw this.error('a name of an element or attribute is missing');
    this.at = NAME.lastIndex;
    return found[0];
  }

  /** Blanks, comments and processing instructions. */
  misc() {
    if (this.at === 0 && this.text.charCodeAt(0) === 0xfeff) this.at = 1;
    for (;;) {
      this.blanks();
      if (this.has('<!--')) this.past('-->', 'a comment');
      else if (this.has('<?')) this.past('?>', 'an instruction');
      else return;
    }
  }

  element(depth) {
    const start = this.at;
    if (depth > MAX_DEPTH) throw this.error('nested too deeply');
    if (this.has('<!')) throw this.error('a document type is not allowed');
    if (!this.has('<')) throw this.error('an element is missing');
    this.at++;
    const element = {name: this.name(), attributes: {}, children: [], text: '', line: this.line(start), source: ''};
    for (this.blanks(); !this.has('>') && !this.has('/>'); this.blanks()) {
      const name = this.name();
      this.blanks();
      if (!this.has('=')) throw this.error(`attribute "${name}" without a value`);
      this.at++;
      this.blanks();
      const quote = this.text.charAt(this.at++);
      if (quote !== '"' && quote !== "'") throw this.error(`the value of attribute "${name}" is not in quotation marks`);
      element.attributes[name] = this.plain(this.past(quote, `attribute "${name}"`));
    }
    if (this.has('/>')) this.at += 2;
    else {
      this.at++;
      this.content(element, depth);
    }
    element.source = this.text.slice(start, this.at);
    element.text = element.text.trim();
    return element;
  }

  content(element, depth) {
    for (;;) {
      if (this.at >= this.text.length) throw this.error(`<${element.name}> without </${element.name}>`);
      if (this.has('</')) {
        this.at += 2;
        const name = this.name();
        if (name !== element.name) throw this.error(`</${name}> where </${element.name}> is expected`);
        this.blanks();
        if (!this.has('>')) throw this.error(`</${name} without ">"`);
        this.at++;
        return;
      }
      if (this.has('<!--')) this.past('-->', 'a comment');
      else if (this.has('<![CDATA[')) {
        this.at += 9;
        element.text += this.past(']]>', 'CDATA');
      } else if (this.has('<?')) this.past('?>', 'an instruction');
      else if (this.has('<')) element.children.push(this.element(depth + 1));
      else {
        const end = this.text.indexOf('<', this.at);
        const text = this.text.slice(this.at, end < 0 ? undefined : end);
        element.text += this.plain(text);
        this.at += text.length;
      }
    }
  }

  plain(text) {
    return text.replace(/&([^;&]{0,10});?/g, (all, name) => {
      const code = /^#(x[\da-fA-F]+|\d+)$/.exec(name);
      if (ENTITIES[name] && all.endsWith(';')) return ENTITIES[name];
      if (code && all.endsWith(';')) {
        const value = code[1].startsWith('x') ? parseInt(code[1].slice(1), 16) : parseInt(code[1], 10);
        if (value > 0 && value <= 0x10ffff) return String.fromCodePoint(value);
      }
      throw this.error(`"${all.slice(0, 12)}" is no character`);
    });
  }
}

export function escapeXml(text) {
  return String(text).replace(/[&<>"']/g, letter => `&#${letter.charCodeAt(0)};`);
}
