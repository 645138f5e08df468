/**
 * Commands by which an operator keeps a running vehicle safe: emergency stop, arming, and being
 * there. What the vehicle makes of them belongs to the core's safety package.
 */
package org.u2sa.gcs.safety;
