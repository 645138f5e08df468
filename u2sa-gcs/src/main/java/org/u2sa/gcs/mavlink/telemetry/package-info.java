/** What the vehicle tells stations: messages made of its latest state, and how often. */
package org.u2sa.gcs.mavlink.telemetry;
