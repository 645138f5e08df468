/**
 * The tasks of Virtual RobotX (osrf/vrx) in its own worlds, judged by its own formulas: {@code u2sa
 * demo vrx}. Nothing of VRX is shipped; the user names a folder with its worlds.
 */
package org.u2sa.scenarios.vrx;
