/**
 * Control of small aeroplanes: laws as pure computation, and the services that run them. One
 * aircraft's parameters are configuration; how surfaces reach a simulator, and where the aircraft
 * is to go, do not belong here.
 */
package org.u2sa.core.control.fixedwing;
