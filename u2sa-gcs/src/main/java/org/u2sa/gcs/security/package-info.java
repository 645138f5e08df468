/**
 * The commands that make what a secured broker needs: a local authority, certificates, users, and
 * the same for Mosquitto. What users may do belongs to the core module.
 */
package org.u2sa.gcs.security;
