/**
 * Commands that show and change the configuration of a running system's services. The connection is
 * in {@code org.u2sa.gcs.remote}.
 */
package org.u2sa.cli.configuration;
