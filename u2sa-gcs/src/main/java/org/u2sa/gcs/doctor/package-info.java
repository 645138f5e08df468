/**
 * What this machine has and lacks for running vehicles, and what to do about each. Nothing is
 * changed; a system that runs is looked at elsewhere.
 */
package org.u2sa.gcs.doctor;
