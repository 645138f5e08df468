/**
 * Framework of control systems (thesis 3.2.3.5): navigation points and states in, commands to
 * actuators out. Control laws of particular vehicles belong to the modules of those vehicles.
 */
package org.u2sa.control;
