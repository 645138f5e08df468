/**
 * Commands that report, compare and export recorded runs. How pages and files are made is
 * u2sa-report's.
 */
package org.u2sa.cli.report;
