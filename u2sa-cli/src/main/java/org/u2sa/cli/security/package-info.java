/**
 * Commands that set up a secured broker: local authority, certificates, users, and their export for
 * Mosquitto. Permissions are defined in the core module.
 */
package org.u2sa.cli.security;
