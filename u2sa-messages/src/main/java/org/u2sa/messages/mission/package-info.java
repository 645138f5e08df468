/** Messages with which a mission is set, changed and reported. */
package org.u2sa.messages.mission;
