/**
 * A page with charts, events and tables of one or several runs, which needs no network. What runs
 * there are, and what is said of them, is its users'.
 */
package org.u2sa.gcs.page;
