/**
 * Lanes over search areas. What was seen is recorded by the World Modeler; how a vehicle is led to
 * a place is the guidance's and the avoidance's matter.
 */
package org.u2sa.planning.survey;
