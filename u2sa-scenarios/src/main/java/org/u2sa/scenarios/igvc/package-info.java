/**
 * The Intelligent Ground Vehicle Competition's course: generated, read and checked courses, the
 * simulated vehicle on them, the judge, and the demo. What the vehicle thinks is configuration of
 * ordinary services and belongs to config/igvc.
 */
package org.u2sa.scenarios.igvc;
