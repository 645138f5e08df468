/**
 * {@code u2sa new}: projects and services from templates (thesis 3.5.1), which an organisation can
 * override or extend. The templates themselves are resources.
 */
package org.u2sa.cli.template;
