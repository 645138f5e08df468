/**
 * What a scanning range finder sees as objects. Maps of free space are the World Modeler's matter.
 */
package org.u2sa.vision.laser;
