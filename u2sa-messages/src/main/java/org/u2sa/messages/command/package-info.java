/** Commands to actuators (thesis 3.2.3.9). */
package org.u2sa.messages.command;
