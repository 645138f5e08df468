/**
 * {@code u2sa mission}: shows a running mission and orders changes of it. What the orders do
 * belongs to the Mission Manager.
 */
package org.u2sa.gcs.mission;
