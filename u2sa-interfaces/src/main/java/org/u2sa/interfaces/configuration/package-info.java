/**
 * Variables of a service and the files that keep them: declaring, checking, changing, undoing.
 * Reading XML as such belongs to {@code interfaces.xml}.
 */
package org.u2sa.interfaces.configuration;
