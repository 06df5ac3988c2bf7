<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%@ attribute name="value" required="true" type="java.lang.Double" description="nothing is shown where there is none" %>
<%@ attribute name="unit" required="true" description="of org.toqa.web.page.Chart" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<c:choose>
  <c:when test="${empty value}"><span class="faint"><fmt:message key="statistics.none"/></span></c:when>
  <c:when test="${unit == 'COUNT'}"><fmt:formatNumber value="${value}" maxFractionDigits="0"/></c:when>
  <c:when test="${unit == 'SHARE'}"><fmt:formatNumber value="${value}" type="percent" maxFractionDigits="1"/></c:when>
  <c:when test="${unit == 'METRES' and value < 10000}"><fmt:formatNumber value="${value}" maxFractionDigits="0" var="metres"/><fmt:message key="common.metres"><fmt:param value="${metres}"/></fmt:message></c:when>
  <c:when test="${unit == 'METRES'}"><fmt:formatNumber value="${value / 1000}" maxFractionDigits="1" var="kilometres"/><fmt:message key="statistics.kilometres"><fmt:param value="${kilometres}"/></fmt:message></c:when>
  <c:otherwise>
    <c:set var="scale" value="${value < 120 ? 'seconds' : value < 7200 ? 'minutes' : 'hours'}"/>
    <fmt:formatNumber value="${value / (scale == 'seconds' ? 1 : scale == 'minutes' ? 60 : 3600)}" maxFractionDigits="1" var="amount"/>
    <fmt:message key="statistics.${scale}"><fmt:param value="${amount}"/></fmt:message>
  </c:otherwise>
</c:choose>
