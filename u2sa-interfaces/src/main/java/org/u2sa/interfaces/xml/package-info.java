/**
 * The one XML reader of the framework: elements with their line numbers, no DTD, no external
 * entities, and edits that touch a single attribute. What an element means (configuration, mission,
 * world, system) belongs to the package that reads it.
 */
package org.u2sa.interfaces.xml;
