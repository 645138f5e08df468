/**
 * Motors: how a percentage becomes a servo pulse, and motor controllers on a serial line that count
 * wheel turns. Who may command them, and when, is the business of {@code org.u2sa.service}.
 */
package org.u2sa.drivers.motor;
