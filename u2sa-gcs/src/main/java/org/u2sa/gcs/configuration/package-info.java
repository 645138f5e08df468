/** Variables of a running system's services: read, changed, undone, watched. */
package org.u2sa.gcs.configuration;
