/**
 * The commands that tell and change the configuration of a running system's services. How they
 * reach it belongs to {@code org.u2sa.gcs.remote}.
 */
package org.u2sa.gcs.configuration;
