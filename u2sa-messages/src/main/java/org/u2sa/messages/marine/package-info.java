/**
 * Objects of surface and underwater courses, such as buoys, hoops and docks (thesis 4.2.1.1 and
 * 4.3.1.2). Plain shapes are in {@code messages.shape}; goals and tasks belong to the scenarios.
 */
package org.u2sa.messages.marine;
