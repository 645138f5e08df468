/**
 * Control of small aeroplanes: laws as pure computation, and the services that run them. Parameters
 * of a particular aircraft are configuration; the link to a simulator and guidance do not belong
 * here.
 */
package org.u2sa.control.fixedwing;
