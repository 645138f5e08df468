/**
 * The Intelligent Ground Vehicle Competition's course: generation, files and checks of courses, the
 * simulated vehicle, the judge, and the demo. The vehicle itself is run by ordinary services,
 * configured in config/igvc.
 */
package org.u2sa.scenarios.igvc;
