/**
 * Framework of control systems (thesis 3.2.3.5): navigation points and states in, commands to
 * actuators out. Control laws are in packages by kind of vehicle: {@code ground}, {@code
 * fixedwing}, and {@code cascade} for boats, submarines and multirotors.
 */
package org.u2sa.control;
