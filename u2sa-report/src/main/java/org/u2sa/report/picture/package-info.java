/**
 * Charts and maps as SVG, PNG and GIF. JFreeChart and Batik are confined to this package; charts of
 * HTML pages are drawn by the page's own script.
 */
package org.u2sa.report.picture;
