/** The log of a service. What goes to SLF4J is not here. */
package org.u2sa.interfaces.log;
