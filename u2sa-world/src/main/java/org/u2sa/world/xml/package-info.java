/** Files of a priori objects (thesis 3.2.3.3). Their use belongs to the World Modeler. */
package org.u2sa.world.xml;
