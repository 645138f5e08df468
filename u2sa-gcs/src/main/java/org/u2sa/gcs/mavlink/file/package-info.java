/** Downloads for stations: virtual files by MAVLink FTP, and recordings as logs. */
package org.u2sa.gcs.mavlink.file;
