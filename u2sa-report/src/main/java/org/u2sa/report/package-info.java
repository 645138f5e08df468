/**
 * Reports of runs: pages, charts, tables, exports. Here: file output and escaping; each format has
 * its own package.
 */
package org.u2sa.report;
