/**
 * {@code u2sa new}: projects and services made of templates (thesis 3.5.1), which an organisation
 * replaces or extends by its own. What a template contains is in the resources, not here.
 */
package org.u2sa.gcs.template;
