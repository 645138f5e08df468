/**
 * A camera that looks down from an aircraft: which ground its images show, and targets on it. Which
 * ground is still missing is recorded by the World Modeler.
 */
package org.u2sa.vision.survey;
