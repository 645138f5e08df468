/**
 * Terminal output: live status, tables. Machine-readable output (JSON, CSV) and pictures are
 * elsewhere.
 */
package org.u2sa.cli.terminal;
