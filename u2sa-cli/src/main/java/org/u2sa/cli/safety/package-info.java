/**
 * Commands by which an operator keeps a running vehicle safe: emergency stop, arming, heartbeat.
 * The vehicle's side is in the core's safety package.
 */
package org.u2sa.cli.safety;
