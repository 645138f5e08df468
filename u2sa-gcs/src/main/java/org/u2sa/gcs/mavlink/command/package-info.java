/** Commands of ground stations: each is answered, at last as unsupported. */
package org.u2sa.gcs.mavlink.command;
