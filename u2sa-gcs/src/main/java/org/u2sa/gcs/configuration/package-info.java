/** Reading, changing, undoing and watching the variables of a running system's services. */
package org.u2sa.gcs.configuration;
