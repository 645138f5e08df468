package org.u2sa.interfaces.xml;

/**
 * Where an element stands in the text of its file, in characters from its beginning.
 *
 * @param start index of the start tag's {@code <}
 * @param endTag index of the end tag's {@code <}; of no meaning for an empty-element tag, which has
 *     none
 */
record XmlSpan(int start, int endTag) {}
