/** Object detection with scanning range finders. Free space is mapped by the World Modeler. */
package org.u2sa.vision.laser;
