/**
 * {@code u2sa mission}: shows a running mission and orders changes. Orders are executed by the
 * Mission Manager.
 */
package org.u2sa.cli.mission;
