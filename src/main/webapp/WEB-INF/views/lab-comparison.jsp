<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="laboratory.comparison" var="title"/>
<t:page title="${title}" here="laboratory">
  <div class="heading">
    <h1>${title}</h1>
    <div class="choices"><a href="${root}/laboratory"><fmt:message key="laboratory.all"/></a></div>
  </div>
  <div class="wide-table" role="region" tabindex="0" aria-label="${title}">
    <table class="comparison">
      <thead>
        <tr>
          <th scope="col"><fmt:message key="laboratory.column.figure"/></th>
          <th scope="col"><fmt:message key="laboratory.column.published"/></th>
          <c:forEach items="${comparison.runs()}" var="view"><th scope="col"><a href="${root}/laboratory/runs/${view.run().id()}"><fmt:message key="laboratory.run"><fmt:param>${view.run().id()}</fmt:param></fmt:message></a></th></c:forEach>
        </tr>
      </thead>
      <tbody>
        <tr><th scope="row"><fmt:message key="laboratory.column.experiment"/></th><td></td><c:forEach items="${comparison.runs()}" var="view"><td><t:english text="${view.run().order().experiment()}"/></td></c:forEach></tr>
        <tr><th scope="row"><fmt:message key="laboratory.column.user"/></th><td></td><c:forEach items="${comparison.runs()}" var="view"><td><bdi><c:out value="${view.run().user()}"/></bdi></td></c:forEach></tr>
        <tr><th scope="row"><fmt:message key="laboratory.column.ordered"/></th><td></td><c:forEach items="${comparison.runs()}" var="view"><td><t:time at="${view.run().orderedAt()}"/></td></c:forEach></tr>
        <tr><th scope="row"><fmt:message key="laboratory.seed"/></th><td></td><c:forEach items="${comparison.runs()}" var="view"><td><bdi>${view.run().order().seed()}</bdi></td></c:forEach></tr>
        <tr><th scope="row"><fmt:message key="laboratory.runs"/></th><td></td><c:forEach items="${comparison.runs()}" var="view"><td><bdi>${view.run().order().runs()}</bdi></td></c:forEach></tr>
        <c:forEach items="${comparison.parameters()}" var="row"><tr><th scope="row"><t:english text="${row.name()}"/></th><td></td><c:forEach items="${row.values()}" var="value"><td><t:english text="${value}"/></td></c:forEach></tr></c:forEach>
        <c:forEach items="${comparison.figures()}" var="row">
          <tr>
            <th scope="row"><t:english text="${row.name()}"/></th>
            <td><t:english text="${row.published()}"/></td>
            <c:forEach items="${row.figures()}" var="figure"><td><c:if test="${not empty figure}"><t:english text="${figure.measured().text()}"/><br><t:lab-verdict verdict="${figure.verdict()}"/></c:if></td></c:forEach>
          </tr>
        </c:forEach>
      </tbody>
    </table>
  </div>
  <c:forEach items="${comparison.drawings()}" var="row">
    <h2><t:english text="${row.title()}"/></h2>
    <div class="charts">
      <c:forEach items="${row.runs()}" var="id"><c:if test="${not empty id}">
        <fmt:message key="laboratory.run" var="of"><fmt:param>${id}</fmt:param></fmt:message>
        <article class="drawing"><p><strong>${of}</strong></p><img src="${root}/api/v1/laboratory/runs/${id}/drawings/${row.name()}" alt="${fn:escapeXml(row.title())}" lang="en" loading="lazy"></article>
      </c:if></c:forEach>
    </div>
  </c:forEach>
</t:page>
