/**
 * Files of objects that are known beforehand (thesis 3.2.3.3). What becomes of them is the World
 * Modeler's matter.
 */
package org.u2sa.world.xml;
