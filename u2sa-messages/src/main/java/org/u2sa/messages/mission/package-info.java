/** Messages to set, change and report a mission. */
package org.u2sa.messages.mission;
