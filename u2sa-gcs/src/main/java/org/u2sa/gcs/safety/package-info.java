/** Confirmation of orders that concern safety. The orders belong to commands and bridges. */
package org.u2sa.gcs.safety;
