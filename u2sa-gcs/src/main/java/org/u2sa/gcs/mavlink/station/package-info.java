/** A ground station as the parts of the bridge address it, and the texts sent to it. */
package org.u2sa.gcs.mavlink.station;
