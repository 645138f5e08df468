/**
 * The framework's only XML reader: elements with line numbers, no DTD, no external entities, and
 * single-attribute edits. The meaning of elements (configuration, mission, world, system) belongs
 * to the reading package.
 */
package org.u2sa.interfaces.xml;
