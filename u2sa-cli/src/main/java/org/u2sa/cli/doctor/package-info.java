/**
 * Checks this machine's prerequisites for running vehicles, and suggests remedies. Changes nothing;
 * running systems are inspected elsewhere.
 */
package org.u2sa.cli.doctor;
