<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="part" required="true" type="org.toqa.mission.OrderPart" description="which part of an order a task is" %>
<%@ attribute name="order" type="org.toqa.fleet.OrderView" description="that order" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<a href="${pageContext.request.contextPath}/orders/${part.order}"><fmt:message key="order.part.${part.kind}"><fmt:param value="${part.position}"/><fmt:param value="${part.count}"/></fmt:message></a>
<c:if test="${not empty order}">${" · "}<fmt:message key="order.progress"><fmt:param value="${order.delivered()}"/><fmt:param value="${order.parts}"/></fmt:message></c:if>
