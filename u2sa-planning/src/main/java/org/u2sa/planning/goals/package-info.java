/** Which of the Mission Manager's goals is pursued, and since when. */
package org.u2sa.planning.goals;
