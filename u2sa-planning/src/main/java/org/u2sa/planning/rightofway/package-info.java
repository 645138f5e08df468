/**
 * Right of way at sea (COLREGs rules 8 and 13 to 17): which rule applies to whom, and what course
 * and speed follow from it. Static obstacles and routes belong elsewhere in the planner.
 */
package org.u2sa.planning.rightofway;
