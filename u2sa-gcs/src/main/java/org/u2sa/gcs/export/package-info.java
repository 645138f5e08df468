/**
 * A recording in formats of others: tables, and tracks on maps. Reading recordings is {@code
 * org.u2sa.gcs.record}'s.
 */
package org.u2sa.gcs.export;
