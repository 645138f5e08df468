/**
 * Reports of runs: pages, charts, tables, exports. Here: how files are written and text is escaped;
 * the parts that know a format are in packages of their own.
 */
package org.u2sa.report;
