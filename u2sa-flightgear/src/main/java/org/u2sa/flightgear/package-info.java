/**
 * Messages that aeroplanes add to the framework's own. Links to simulators and control laws stand
 * in packages of their own.
 */
package org.u2sa.flightgear;
