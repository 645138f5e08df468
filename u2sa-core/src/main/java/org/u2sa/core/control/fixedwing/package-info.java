/**
 * Control of the Cessna 172: laws as pure computation, and the services that run them. How surfaces
 * reach a simulator, and where the aircraft is to go, do not belong here.
 */
package org.u2sa.core.control.fixedwing;
