/** Telemetry: messages made from the vehicle's latest state, and their rates. */
package org.u2sa.gcs.mavlink.telemetry;
