/**
 * A self-contained page with charts, events and tables of one or several runs. The content comes
 * from its callers.
 */
package org.u2sa.report.page;
